(** Bonds on an edge or a corner that several faces of a body share, all of them open: that a face opens its edges
    is the paper's (Definition 4.2), and often not what was meant. *)

open Scc_state_space

val warning : Network_lts.context -> Scc_base.Diag.t option
(** SC0706 of one bond of an exploration that was made so, by the order of what is told: at an end which no
    channel lists, and which is in the closures of two features that channels of the leaf list. *)
