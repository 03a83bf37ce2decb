(** Motion in translation: the kinematics of the translational calculus, in which nothing turns (rules Approach,
    Ftoc, Response). *)

include Kinematics.S
