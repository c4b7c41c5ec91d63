"""The surface on which cloth lies: the skin, or a distance outside of it where there is ease."""
