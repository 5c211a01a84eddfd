"""What a user meets: commands and figures."""
