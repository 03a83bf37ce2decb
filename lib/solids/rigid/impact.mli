(** What a collision, a bond and a split do to the velocities and spins of rigid bodies (rules Bounce, Bind and
    Split of the rigid calculus). Exact: momentum, angular momentum and kinetic energy are kept as each rule says.
*)

open Scc_exact

type mover = {
  mass : Mass.t option;  (** where its mass is now; [None] for a fixed body, which stays at rest *)
  velocity : Vec.t;  (** of the centre of mass *)
  spin : Vec.t;
}

val velocity_at : mover -> Vec.t -> Vec.t
(** Of the point of the body that is now at a place; zero for a fixed body. *)

val approaching : mover -> mover -> Near_contact.t -> bool
(** Whether at some corner x of the region n.w(x) < 0 for every normal n of the contact, where w(x) is the
    velocity of the second body at x less that of the first. *)

(** A normal n of a contact, from the body with the one number to that with the other, at a corner x. *)
type contact = { first : int; second : int; normal : Ivec.t; corner : Vec.t }

val reflect : mover array -> contact list -> mover array option
(** The elastic response of some bodies. The generalized normal of a contact is the row J that takes the
    velocities q of the bodies to n.w(x), with w(x) the velocity of the second at x less that of the first. N is
    the cone spanned by them, and q+ = q + 2 proj(-q), the projection on N in the kinetic metric
    ({!Scc_exact.Reflection}). Momentum (of what touches nothing fixed), angular momentum and kinetic energy
    stay what they were; a fixed body takes nothing. Where J q < 0 before, J q+ >= -J q after; at another corner
    two may approach then, and that is another collision of the same instant. [None] iff J q >= 0 for all: the
    response would be zero. *)

(** All contacts of a part of one body, by its number, with a part of another. *)
type encounter = { one : int; two : int; contacts : Near_contact.t list }

val bounce_all : mover array -> encounter list -> mover array option
(** {!reflect} for the encounters of some bodies: of each, at all corners of the approaching contacts, their
    normals that count ({!Inner_corners}), or all their normals if the response to those that count is zero.
    [None] iff no contact approaches. *)

type response = Bounced of mover * mover | Persistent  (** the response would be zero *)

val bounce : mover -> mover -> Near_contact.t list -> response
(** {!bounce_all} of two bodies. *)

val pushed : at:Vec.t -> Vec.t -> mover -> mover
(** What an impulse at a place gives a body; a fixed body takes nothing. *)

val bind : mover list -> mover
(** The whole of some bodies (at least one), which moves by conservation of linear and angular momentum. What is
    bound to a fixed body is fixed. *)

val piece : mover -> Mass.t option -> mover
(** What splits off from a body keeps its rigid motion: the velocity of its own centre of mass, and the spin. A
    piece of a fixed body starts from rest. *)
