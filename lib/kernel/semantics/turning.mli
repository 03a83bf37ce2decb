(** The kinematics of the rigid calculus, in which bodies turn as they move (rules Turn, Cast, Near, Impact and
    Persistent). *)

include Kinematics.S
