"""From claims to rows: checks are run, in several processes and from the cache, and each row is judged."""
