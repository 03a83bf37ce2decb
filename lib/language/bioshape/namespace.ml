let uri = "urn:scc:bioshape:1"
