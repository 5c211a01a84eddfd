"""What the tests of the audit share."""


def quiet(_):
    pass


def row_of(rows):
    (row,) = rows
    return row
