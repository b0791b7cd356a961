"""Reports: what runs show, in numbers with intervals, in pictures, and answer by answer."""
