(** Rules Contact, Approach and Ftoc as conditions on the facets of an obstacle, one by one. The {b room} of an
    offset at a facet is num/den - normal . offset: positive inside of its plane, negative beyond. The {b speed} at
    a facet is normal . velocity, by which room falls in a unit of time.

    A condition holds iff the room at each facet has the sign that is needed. {!Facets} evaluates these conditions
    over integers for one offset, and the room [lib/solids/offsets] makes linear constraints of them. *)

type need = Positive | Not_negative

val holds : need -> int -> bool
(** [holds need sign] is true if a room of this sign is what is needed. *)

val contact : need
(** Rule Contact, at each facet: the closed bodies have a common point. *)

val overlap : need
(** Rule Contact, at each facet: the interiors of the bodies have a common point. *)

val collision : speed:int -> need
(** Rules Contact and Approach, at a facet with a speed of this sign: the interiors of the bodies have a common
    point at all times right after now. *)

(** When the room at a facet is as needed, at a constant speed. The {b crossing} is room / speed, the time at which
    room is 0. *)
type times =
  | From  (** after the crossing, and at it if room need not be positive *)
  | Until  (** before the crossing, and at it if room need not be positive *)
  | Always_or_never  (** room does not change *)

val times : speed:int -> times
(** [times ~speed] is for a speed of this sign. By rule Ftoc, two bodies collide at the last crossing of a facet of
    kind [From], if {!overlap} holds right after it. *)
