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

type response = Bounced of mover * mover | Persistent  (** the response would be zero *)

val reflect : mover -> mover -> (Ivec.t * Vec.t) list -> response
(** The elastic response for given normals n, from the first body to the second, each at a corner x. The
    generalized normal of the two is the row J that takes the velocities q of the two bodies to n.w(x). N is the
    cone spanned by them, and q+ = q + 2 proj(-q), the projection on N in the kinetic metric (Moreau). Momentum (if
    neither body is fixed), angular momentum and kinetic energy stay what they were; a fixed body takes nothing.
    Where J q < 0 before, J q+ >= -J q after; at another corner the two may approach then, and that is another
    collision of the same instant. [Persistent] iff J q >= 0 for all. *)

val bounce : mover -> mover -> Near_contact.t list -> response
(** {!reflect} for all contacts of a part of the first body with a part of the second: at all corners of the
    approaching contacts, their normals that count ({!Inner_corners}), or all their normals if the response to
    those that count is zero. [Persistent] iff no contact approaches. *)

val bind : mover list -> mover
(** The whole of some bodies (at least one), which moves by conservation of linear and angular momentum. What is
    bound to a fixed body is fixed. *)

val piece : mover -> Mass.t option -> mover
(** What splits off from a body keeps its rigid motion: the velocity of its own centre of mass, and the spin. A
    piece of a fixed body starts from rest. *)
