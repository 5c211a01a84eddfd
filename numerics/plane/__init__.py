"""The pair on a surface: friction with a direction. A room that stands on the scene, the arithmetic and balls only."""
