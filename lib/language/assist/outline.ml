open Scc_base
open Scc_syntax
open Scc_describe

type node = {
  name : string;
  kind : string;
  about : string;
  at : Span.t;
  name_at : Span.t;
  inner : node list;
}

type fold = { from : int; upto : int; comment : bool }

(* {1 The tree} *)

let within (at : Span.t) (inner : Span.t) = at.start <= inner.start && inner.stop <= at.stop

let rec of_declared (all : Declared.all) at (d : Declared.t) =
  let at = match d.shown with Some shown when within at shown && within shown d.name.at -> shown | _ -> at in
  let own (i : Declared.t) = within at i.name.at in
  let inner = List.filter own d.inner in
  let child (i : Declared.t) =
    let at = match i.shown with Some shown -> shown | None -> i.name.at in
    of_declared all at i
  in
  {
    name = d.name.it; kind = Declared.kind d.kind; about = d.what; at; name_at = d.name.at;
    inner = List.map child inner;
  }

let named (i : Ast.item) : Ast.name list =
  match i.it with
  | Model n | Param (n, _) | Param_in (n, _, _) | Let (n, _) | Check (n, _) -> [ n ]
  | Shape (h, _, _) | Compound (h, _, _, _) | Decomposed (h, _, _, _) | Behaviour (h, _, _, _) -> [ h.declared ]
  | Process (s, _, _) | Fixed (s, _, _) -> [ s.name ]
  | _ -> []

let range (r : Ast.range) =
  Printf.sprintf "%s in %s..%s" r.index.it (Printer.expr r.bounds.low) (Printer.expr r.bounds.high)

let rec of_item all (i : Ast.item) =
  let plain name kind name_at inner = [ { name; kind; about = ""; at = i.at; name_at; inner } ] in
  match i.it with
  | For (ranges, items) ->
    let name = "for " ^ String.concat ", " (List.map range ranges) in
    let name_at = match ranges with r :: _ -> r.index.at | [] -> i.at in
    plain name "loop" name_at (List.concat_map (of_item all) items)
  | Import { from; _ } -> plain from.it "import" from.at []
  | Motion (Some p, _) -> plain ("motion " ^ Printer.expr { it = Ast.Path p; at = p.at }) "motion" p.at []
  | Motion (None, _) -> plain "motion" "motion" i.at []
  | _ -> List.map (of_declared all i.at) (List.concat_map (Declared.at all) (named i))

let of_text (r : Reading.t) =
  let all = (Lazy.force r.uses).all in
  List.concat_map (of_item all) (Lazy.force r.model)

(* {1 Folding} *)

let brackets (t : Tokens.t) =
  let one i opening =
    if opening < 0 then None
    else Some { from = t.tokens.(opening).stop; upto = t.tokens.(i).start; comment = false }
  in
  List.filter_map Fun.id (Array.to_list (Array.mapi one t.opening))

(* From the first of some comments in neighbouring lines to the last. *)
let comments source (trivia : Trivia.t list) =
  let line offset = fst (Source.position source offset) in
  let add folds (c : Trivia.t) =
    match (c.kind, folds) with
    | Blank, _ -> folds
    | Line, (fold, last) :: rest when c.own_line && last >= 0 && line c.start = last + 1 ->
      ({ fold with upto = c.stop }, line c.start) :: rest
    | Line, _ ->
      ({ from = c.start; upto = c.stop; comment = true }, if c.own_line then line c.start else -1) :: folds
    | Block, _ -> ({ from = c.start; upto = c.stop; comment = true }, -1) :: folds
  in
  List.rev_map fst (List.fold_left add [] trivia)

let rec items (model : Ast.model) =
  let one (i : Ast.item) =
    let own = { from = i.at.start; upto = i.at.stop; comment = false } in
    match i.it with For (_, inner) -> own :: items inner | _ -> [ own ]
  in
  List.concat_map one model

let folds (r : Reading.t) =
  let tokens = Lazy.force r.tokens in
  items (Lazy.force r.model) @ brackets tokens @ comments r.source tokens.trivia
