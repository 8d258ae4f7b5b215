"""Problems of Python: what is wrong with the code of activities, modules and functions."""
