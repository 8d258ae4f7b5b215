"""Coverage: what runs have reached of a model, counted from their records."""
