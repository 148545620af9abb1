from .scout import Scout
