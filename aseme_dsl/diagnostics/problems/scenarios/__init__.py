"""What can be wrong in scenarios and properties, and in the networks that are simulated for them."""
