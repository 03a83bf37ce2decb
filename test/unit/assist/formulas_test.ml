(* What is offered within formulas, at each token of each check of the models: the name or word that stands there
   is among it, and what is offered goes on with the text before it, as far as the grammar tells. SCC_TELL=1 prints
   what does not. *)

open Scc_base
open Scc_syntax
open Scc_assist
open Texts

let tell = Option.is_some (Sys.getenv_opt "SCC_TELL")
let places = ref 0 and found = ref 0 and offered = ref 0 and fitting = ref 0
let misses : (string, int) Hashtbl.t = Hashtbl.create 64

let note what =
  if tell then Hashtbl.replace misses what (1 + Option.value ~default:0 (Hashtbl.find_opt misses what))

(* A text begins a declaration of the language if its first error is at its end. *)
let is_beginning text =
  (* a word may be longer: what follows is another one *)
  match Parse.parse (Source.make ~name:"m.sc" text) with
  | Ok _ -> true
  | Error errors -> List.for_all (fun (d : Diag.t) -> d.span.start >= String.length text) errors

let rec checks (model : Ast.model) =
  let one (i : Ast.item) =
    match i.it with Check (n, e) -> [ (i, n, e) ] | For (_, inner) -> checks inner | _ -> []
  in
  List.concat_map one model

let model (_, text) =
  let r = reading text in
  let known = Known.of_text modules r and tokens = (Lazy.force r.tokens).tokens in
  let is_word (t : Tokens.token) =
    let c = text.[t.start] in
    (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')
  in
  let at (i : Ast.item) (t : Tokens.token) before =
    let stands = String.sub text t.start (t.stop - t.start) in
    let all = snd (Completion.at known text t.start) in
    incr places;
    let is (o : Completion.offer) = List.hd (String.split_on_char '.' o.name) = stands in
    if List.exists is all then incr found else note (Printf.sprintf "absent: %s after %s" stands before);
    let start = String.sub text i.at.start (t.start - i.at.start) in
    let check (o : Completion.offer) =
      incr offered;
      if is_beginning (start ^ o.name) then incr fitting
      else note (Printf.sprintf "does not fit: %s (%s) after %s" o.name o.kind before)
    in
    List.iter check all
  in
  let one ((i : Ast.item), _, (e : Ast.expr)) =
    let before = ref ":" in
    Array.iter
      (fun (t : Tokens.token) ->
         if e.at.start <= t.start && t.stop <= e.at.stop then begin
           if is_word t then at i t !before;
           before := String.sub text t.start (t.stop - t.start)
         end)
      tokens
  in
  List.iter one (checks (Lazy.force r.model))

let share a b = 1000 * a / Int.max 1 b

let sweep () =
  let all = all_models () in
  let some = if tell then all else List.filteri (fun k _ -> k mod 6 = 0) all in
  List.iter model some;
  let counted = List.sort (fun (_, a) (_, b) -> Int.compare b a) (List.of_seq (Hashtbl.to_seq misses)) in
  List.iteri (fun k (what, n) -> if k < 60 then Printf.printf "%d %s\n" n what) counted;
  let told = Printf.sprintf "%d of %d found, %d of %d fit" !found !places !fitting !offered in
  Printf.printf "%s\n" told;
  Alcotest.(check bool) told true (share !found !places >= 980 && share !fitting !offered >= 999)

let () = Alcotest.run "formulas" [ ("what is offered", [ case "at each token" sweep ]) ]
