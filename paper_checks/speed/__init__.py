"""The report's chapter on speed and accuracy: written sentences, their numbers filled in from a recorded trade."""
