"""What a process that answers may do wrong; importable by it, wherever it is started, in no time."""

import os


def answers_or_dies(task, given):
    """Answer, and end without a word when asked for the task `lost`."""
    return os._exit(7) if task == "lost" else task + given
