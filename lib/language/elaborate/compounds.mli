(** Compound shapes (Definition 4.5): parts glued into a tree, each two at their touching features of the
    highest dimension. The parts move as one body and do not interpenetrate. *)

open Scc_syntax

val declare : Context.t -> Env.t -> Ast.head -> Ast.part list -> Ast.glue list -> Ast.definitions -> unit
(** Enters a compound or a family of compounds among the templates. Codes: SC0401 and SC0402 (features of a
    glue), SC0403 (overlap), SC0404 (motion), SC0405 (glues that are no tree). *)
