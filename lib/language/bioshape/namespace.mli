(** The namespace of models in XML, as [specs/schema/bioshape.xsd] has it; a change that breaks readers changes
    it. *)

val uri : string
