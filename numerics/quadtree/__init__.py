"""Maps of proved cells: a window cut into quarters until each is decided; resumable, in processes or on a cluster."""
