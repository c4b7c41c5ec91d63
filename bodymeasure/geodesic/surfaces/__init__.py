"""The surfaces that paths run on: Bezier patches, rational ones, and those of users."""
