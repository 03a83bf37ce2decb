open Scc_state_sets

(** Rule Symmetry for zones: of zones that differ by a permutation of interchangeable leaves, one is followed.
    No order of leaves is the same in all states of a zone. An order that depends on the zone as a whole is
    enough. It uses first the properties that no renaming changes. *)

val image : classes:int list list -> Zone.t -> int array option
(** [image ~classes z] has, for each leaf, the leaf whose name it gets. Then the members of each class come in
    order, and those that are left come first (rule Absorb). [None] if they are in order already. *)
