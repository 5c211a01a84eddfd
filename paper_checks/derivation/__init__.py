"""The derivation as mathematics: from (2)-(4) to the 1/t law, line by line, each line with its check and its claim."""
