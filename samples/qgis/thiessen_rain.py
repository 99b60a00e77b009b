"""A Processing script: the areal rainfall of basins, a row for each time step. See README.md beside this file."""

import os
import sys

from qgis.core import QgsProcessingAlgorithm, QgsProcessingParameterEnum, QgsProcessingParameterFileDestination

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from thiessen_program import ThiessenScript, in_place  # noqa: E402


class ThiessenRain(ThiessenScript, QgsProcessingAlgorithm):
    OUTPUT = "OUTPUT"

    def createInstance(self):
        return ThiessenRain()

    def name(self):
        return "thiessenrain"

    def displayName(self):
        return "Areal rainfall"

    def shortHelpString(self):
        return ("The mean rainfall of each basin at each step of the readings, by the cells of the gauges that report "
                "then: a table of time and a column for each basin.")

    def initAlgorithm(self, config=None):
        self.add_places(basins_optional=False)
        self.add_readings(optional=False)
        self.addParameter(QgsProcessingParameterEnum(
            self.GAPS, "Steps with silent gauges",
            ["cells of the gauges that report", "weights scaled to the gauges that report", "no value"],
            defaultValue=0))
        self.add_method()
        self.addParameter(QgsProcessingParameterFileDestination(self.OUTPUT, "Areal rainfall", "CSV (*.csv)"))

    def processAlgorithm(self, parameters, context, feedback):
        words, options = self.places(parameters, context, feedback)
        words.append(self.parameterAsFile(parameters, self.RAINFALL, context))
        gaps = self.POLICIES[self.parameterAsEnum(parameters, self.GAPS, context)]
        output = self.parameterAsFileOutput(parameters, self.OUTPUT, context)
        in_place(output, ["rain", *words, *options, "--gaps", gaps, *self.method(parameters, context)], feedback)
        return {self.OUTPUT: output}
