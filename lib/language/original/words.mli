(** The words of the original notation, made words of the grammar of [lib/language/syntax]: each channel [<a, X>]
    and split [omega(a, X)] one whose only feature holds the region X, each bond [<a, X * Y>] and [glue X * Y] one
    of two such features, [region R on S = X] and [curved inscribed d] declarations of values ({!Tree}), and each
    tuple [<H, m, p, v>] in the place of a shape the solid H with its mass, place and velocity. Every token keeps
    its place.

    Faults: SC0360 (features in braces), SC0364 (a bond or glue without [*]), SC0206 (a tuple that is not of
    four). *)

open Scc_base
open Scc_syntax

val rewrite : file:string -> Tokens.token array -> Tokens.token array * Diag.t list
