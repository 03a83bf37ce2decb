(** Bonds on an edge or a corner that several open faces of a body share. An open face opens its edges, too
    (Definition 4.2), which is often not intended. *)

open Scc_state_space

val warning : Network_lts.context -> Scc_base.Diag.t option
(** SC0706 for the first, in the order of diagnostics, of such bonds in an exploration. One end of the bond is
    listed by no channel, and is in the closures of two features that channels of the leaf list. [None] if
    there is no such bond. *)
