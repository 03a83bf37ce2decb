(** The namespace of models in XML, as in [specs/schema/bioshape.xsd]. *)

val uri : string
(** The name of the namespace: ["urn:scc:bioshape:1"]. A change that breaks readers changes it. *)
