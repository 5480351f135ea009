# Install rules are added below.
