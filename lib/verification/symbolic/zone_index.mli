(** Canonical zones by what one that has another, or merges with it, must share with it: so that none of the others
    is looked at. *)

type 'a t

val create : unit -> 'a t

val add : 'a t -> Zone.t -> 'a -> unit
(** What goes by a canonical zone. The zone may grow later, by {!Zone.merged}. *)

val alike : 'a t -> Zone.t -> 'a list
(** What goes by zones of the kind that have the {!Zone.same_forms}, the last one first. *)

val last_around : 'a t -> Zone.t -> ('a -> 'b option) -> 'b option
(** Of what goes by zones that may have all of this canonical one ({!Zone.included}), the last for which there is
    an answer. All zones that have all of it are looked at, until then. *)
