"""Steps of arguments that several claims share; each returns the evidence for one step."""
