(** From the words of the original notation to those of the grammar of [lib/language/syntax]. Every token keeps
    its place.

    - Each channel [<a, X>] and split [omega(a, X)] becomes one whose only feature contains the region X.
    - Each bond [<a, X * Y>] and each [glue X * Y] becomes one of two such features.
    - [region R on S = X] and [curved inscribed d] become declarations of values ({!Tree}).
    - Each tuple [<H, m, p, v>] in the place of a shape becomes the solid H with its mass, place and velocity.

    Faults: SC0360 (features in braces), SC0364 (a bond or glue without [*]), SC0206 (a tuple that is not of
    four). *)

open Scc_base
open Scc_syntax

val rewrite : file:string -> Tokens.token array -> Tokens.token array * Diag.t list
(** Rewrites the tokens of a file. A token that fits no rule is unchanged. The second result is the faults, in
    the order of the text. *)
