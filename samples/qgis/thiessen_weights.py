"""A Processing script: the weights of rain gauges in basins. See README.md beside this file."""

import os
import sys

from qgis.core import QgsProcessingAlgorithm, QgsProcessingParameterFileDestination

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from thiessen_program import ThiessenScript, in_place  # noqa: E402


class ThiessenWeights(ThiessenScript, QgsProcessingAlgorithm):
    OUTPUT = "OUTPUT"

    def createInstance(self):
        return ThiessenWeights()

    def name(self):
        return "thiessenweights"

    def displayName(self):
        return "Thiessen weights"

    def shortHelpString(self):
        return ("The share of each basin that lies in each gauge's cell: a table of basin, station, area_km2 and "
                "weight. The weights of a basin add up to 1.")

    def initAlgorithm(self, config=None):
        self.add_places(basins_optional=False)
        self.add_method()
        self.addParameter(QgsProcessingParameterFileDestination(self.OUTPUT, "Weights", "CSV (*.csv)"))

    def processAlgorithm(self, parameters, context, feedback):
        words, options = self.places(parameters, context, feedback)
        output = self.parameterAsFileOutput(parameters, self.OUTPUT, context)
        in_place(output, ["weights", *words, *options, *self.method(parameters, context)], feedback)
        return {self.OUTPUT: output}
