"""Problems: a class for each thing that can be wrong, in the order of their codes, and with its texts."""
