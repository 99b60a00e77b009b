from .study import Study as Study
from .study import ThiessenWarning as ThiessenWarning

__version__: str

class Error(ValueError): ...
