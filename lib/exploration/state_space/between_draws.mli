(** Whether a check sees the states between the draws of one instant (rule JoinedDraws). The answers are
    conservative: a check that sees nothing there may count as one that does. *)

open Scc_property

val unseen : Property.check -> bool
(** [unseen c] is true if [c] has the same answer when the draws and lots of one instant are one transition. It is
    so if [c] asks for no number of events, and its formula has no X, no [event], and no operator of time below
    another one. *)

val is_number : Property.check -> bool
(** [is_number c] is true if [c] asks for a probability or a mean, so that no claim is explained. *)

val velocities_unseen : Property.check -> bool
(** [velocities_unseen c] is true if [c] asks for a number, and no atom of it depends on velocities. Then it does
    not depend on the velocity that a process has while it waits to draw another one. *)
