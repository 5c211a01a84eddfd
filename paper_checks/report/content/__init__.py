"""What the report says, as blocks of text, tables and figures: nothing here knows how they are written."""
