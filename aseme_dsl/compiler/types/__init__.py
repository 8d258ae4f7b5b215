"""Types: values and expressions, activities and modules, with the types they have."""
