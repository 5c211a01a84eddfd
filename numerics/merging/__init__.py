"""Who merges from where: proved cells over mass ratio and energy."""
