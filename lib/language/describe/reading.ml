open Scc_base
open Scc_syntax

type t = {
  source : Source.t;
  tokens : Tokens.t Lazy.t;
  model : Ast.model Lazy.t;
  uses : Uses.t Lazy.t;
}

let is_plain source = String.equal (Scc_notation.Notation.of_source source).name "sc"

let make source =
  let tokens = lazy (Tokens.read source) in
  let read () =
    if is_plain source then Parse.readable ~tokens:(fun _ -> Lazy.force tokens) source
    else Scc_notation.Notation.readable source
  in
  let model = lazy (read ()) in
  let uses = lazy (Uses.of_model (Declared.of_model (Lazy.force model)) (Lazy.force model)) in
  { source; tokens; model; uses }

(* Which one the offset is in, and which one ends there. *)
let tokens_at (t : Tokens.t) offset =
  let count = Array.length t.tokens - 1 in
  (* the first that ends after the offset *)
  let rec search low high =
    if low >= high then low
    else
      let middle = (low + high) / 2 in
      if t.tokens.(middle).stop > offset then search low middle else search (middle + 1) high
  in
  let i = search 0 count in
  let within i = i < count && t.tokens.(i).start <= offset in
  let ends i = i >= 0 && t.tokens.(i).stop = offset in
  List.filter within [ i ] @ List.filter ends [ i - 1 ]

