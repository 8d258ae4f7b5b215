"""What z3 says of conditions."""
