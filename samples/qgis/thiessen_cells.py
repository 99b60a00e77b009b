"""A Processing script: Thiessen cells, clipped to basins. See README.md beside this file."""

import os
import sys

from qgis.core import QgsProcessingAlgorithm, QgsProcessingParameterVectorDestination

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from thiessen_program import ThiessenScript, to_destination  # noqa: E402


class ThiessenCells(ThiessenScript, QgsProcessingAlgorithm):
    OUTPUT = "OUTPUT"

    def createInstance(self):
        return ThiessenCells()

    def name(self):
        return "thiessencells"

    def displayName(self):
        return "Thiessen cells"

    def shortHelpString(self):
        return ("The cells of rain gauges, each the ground nearer to its gauge than to any other, exact on the Earth, "
                "and clipped to the basins; without basins, to the extent of the gauges. Fields: station, basin, "
                "area_km2, weight.")

    def initAlgorithm(self, config=None):
        self.add_places(basins_optional=True)
        self.add_method()
        self.addParameter(QgsProcessingParameterVectorDestination(self.OUTPUT, "Cells"))

    def processAlgorithm(self, parameters, context, feedback):
        words, options = self.places(parameters, context, feedback)
        output = self.parameterAsOutputLayer(parameters, self.OUTPUT, context)
        arguments = ["cells", *words, *options, *self.method(parameters, context)]
        return {self.OUTPUT: to_destination(output, arguments, context, feedback)}
