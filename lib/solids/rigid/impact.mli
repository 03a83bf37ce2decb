(** Changes of velocities and spins of rigid bodies by collisions, bonds and splits (rules Bounce, Bind and
    Split of the rigid calculus). Exact: momentum, angular momentum and kinetic energy are conserved as each
    rule says. *)

open Scc_exact

type mover = {
  mass : Mass.t option;  (** where its mass is now; [None] for a fixed body, which stays at rest *)
  velocity : Vec.t;  (** of the centre of mass *)
  spin : Vec.t;
}

val velocity_at : mover -> Vec.t -> Vec.t
(** [velocity_at m x] is the velocity of the point of the body that is now at [x]; zero for a fixed body. *)

val approaching : mover -> mover -> Near_contact.t -> bool
(** [approaching a b c] is true if n.w(x) < 0 for every normal n of the contact, at some corner x of its
    region. Here w(x) is the velocity of the second body at x less that of the first. *)

(** A normal n of a contact, from the body number [first] to the body number [second], at a corner x. *)
type contact = { first : int; second : int; normal : Ivec.t; corner : Vec.t }

val reflect : mover array -> contact list -> mover array option
(** The elastic response of some bodies. The generalized normal of a contact is the row J that takes the
    velocities q of the bodies to n.w(x). Here w(x) is the velocity of the second body at x less that of the
    first. N is the cone spanned by the generalized normals. The new velocities are q+ = q + 2 proj(-q), with
    the projection on N in the kinetic metric ({!Scc_exact.Reflection}). Momentum (of bodies that touch nothing
    fixed), angular momentum and kinetic energy are conserved; a fixed body stays at rest. Where J q < 0
    before, J q+ >= -J q after. At another corner two bodies may approach then, which is another collision of
    the same instant. [None] iff J q >= 0 for all: the response would be zero. *)

(** All contacts of a part of one body, by its number, with a part of another. *)
type encounter = { one : int; two : int; contacts : Near_contact.t list }

val bounce_all : mover array -> encounter list -> mover array option
(** [bounce_all movers encounters] is {!reflect} for the contacts of some bodies. For each encounter, it takes
    the normals that count ({!Inner_corners}) of the approaching contacts, at all corners. If the response to
    those is zero, it takes all normals of these contacts. [None] iff no contact approaches. *)

type response = Bounced of mover * mover | Persistent  (** the response would be zero *)

val bounce : mover -> mover -> Near_contact.t list -> response
(** [bounce a b contacts] is {!bounce_all} for two bodies. *)

val pushed : at:Vec.t -> Vec.t -> mover -> mover
(** [pushed ~at impulse m] is the body after an impulse at a place; a fixed body is unchanged. *)

val bind : mover list -> mover
(** The whole of at least one body. It moves by conservation of linear and angular momentum. If one of the
    bodies is fixed, the whole is fixed. *)

val piece : mover -> Mass.t option -> mover
(** [piece whole mass] is a piece that splits off from a body, by its mass. It keeps the rigid motion: the
    velocity of its own centre of mass, and the spin. A piece of a fixed body starts from rest. *)
