"""The motions as they stood before the one text: an oracle, until that has their bits."""
