"""Disks laid flat: roughly and conformally first, then with every edge of the border kept."""
