open Scc_state_sets

(** An index of canonical zones by what two zones must share if one contains the other or they merge. Lookups
    consider few of the other zones. *)

(** An index from zones to values of type ['a]. *)
type 'a t

val create : unit -> 'a t
(** An empty index. *)

val add : 'a t -> Zone.t -> 'a -> unit
(** [add index zone x] enters [x] under a canonical zone, which may grow later by {!Zone_form.merged}. *)

val alike : 'a t -> Zone.t -> 'a list
(** [alike index zone] is the values under zones of the same kind that have the {!Zone_form.same_forms}, the last
    one first. *)

val last_around : 'a t -> Zone.t -> ('a -> 'b option) -> 'b option
(** [last_around index zone test] is the answer of [test] for the last value that has one, among those under zones
    that may include the canonical [zone] ({!Zone_form.included}). It tries every value under a zone that does
    include it, until there is an answer. *)
