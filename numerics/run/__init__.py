"""The loop: locate, flow, snap, record; rows of an array; one scene."""
