"""Commands that study the methods: bench and paper."""
