open Scc_exact

type extent = Instant | Lasts of Rat.t | Forever
type 'a piece = { cut : Algebraic.t; at : 'a; after : 'a }
type 'a t = { extent : extent; start : 'a; first : 'a; rest : 'a piece list }

let constant extent a = { extent; start = a; first = a; rest = [] }
let after_start extent a b = { extent; start = a; first = b; rest = [] }

let of_pieces extent ~start ~first rest =
  let is_before cut = match extent with
    | Instant -> false
    | Lasts d -> Algebraic.compare_rat cut d < 0
    | Forever -> true
  in
  let rec increase low = function
    | [] -> true
    | p :: rest -> Algebraic.compare low p.cut < 0 && is_before p.cut && increase p.cut rest
  in
  if increase Algebraic.zero rest then Some { extent; start; first; rest } else None

let map f t =
  let piece p = { cut = p.cut; at = f p.at; after = f p.after } in
  { extent = t.extent; start = f t.start; first = f t.first; rest = List.map piece t.rest }

(* [x] and [y] are the values on the open pieces before the cuts still to come. *)
let rec merge f x y a b acc =
  match (a, b) with
  | [], [] -> List.rev acc
  | p :: a', [] -> merge f p.after y a' [] ({ cut = p.cut; at = f p.at y; after = f p.after y } :: acc)
  | [], q :: b' -> merge f x q.after [] b' ({ cut = q.cut; at = f x q.at; after = f x q.after } :: acc)
  | p :: a', q :: b' ->
    let c = Algebraic.compare p.cut q.cut in
    if c < 0 then merge f p.after y a' b ({ cut = p.cut; at = f p.at y; after = f p.after y } :: acc)
    else if c > 0 then merge f x q.after a b' ({ cut = q.cut; at = f x q.at; after = f x q.after } :: acc)
    else
      merge f p.after q.after a' b'
        ({ cut = p.cut; at = f p.at q.at; after = f p.after q.after } :: acc)

let map2 f a b =
  {
    extent = a.extent;
    start = f a.start b.start;
    first = f a.first b.first;
    rest = merge f a.first b.first a.rest b.rest [];
  }

(* A rational strictly between an instant and the next one, or the end of the extent. *)
let inner extent low next =
  match (next, extent) with
  | Some high, _ -> Algebraic.between low high
  | None, Lasts d -> Algebraic.between low (Algebraic.of_rat d)
  | None, (Forever | Instant) ->
    Rat.add Rat.one (snd (Algebraic.enclose low ~width:Rat.one))

let strictly_between low next r =
  Algebraic.compare low r < 0
  && match next with None -> true | Some high -> Algebraic.compare r high < 0

let next_cut = function [] -> None | p :: _ -> Some p.cut

let refine ~roots ~at ~inside t =
  (* The open piece of value [v] after [low], cut at its roots; pieces are consed onto [acc], which begins
     with the cut at [low] still without its [after]. *)
  let open_piece low next v =
    let limit =
      match (next, t.extent) with
      | Some _, _ | None, (Forever | Instant) -> next
      | None, Lasts d -> Some (Algebraic.of_rat d)
    in
    let cuts =
      match t.extent with Instant -> [] | _ -> List.filter (strictly_between low limit) (roots v)
    in
    let value from until = inside (inner t.extent from until) v in
    (* From the last cut to the first. *)
    let rec go after pieces = function
      | [] -> (after, pieces)
      | c :: before ->
        let from = match before with d :: _ -> d | [] -> low in
        go (value from (Some c)) ({ cut = c; at = at c v; after } :: pieces) before
    in
    match List.rev cuts with
    | [] -> (value low next, [])
    | last :: _ as cuts -> go (value last next) [] cuts
  in
  let rec pieces acc = function
    | [] -> List.rev acc
    | p :: later ->
      let after, inner = open_piece p.cut (next_cut later) p.after in
      pieces (List.rev_append inner ({ cut = p.cut; at = at p.cut p.at; after } :: acc)) later
  in
  let first, cuts = open_piece Algebraic.zero (next_cut t.rest) t.first in
  { extent = t.extent; start = at Algebraic.zero t.start; first; rest = cuts @ pieces [] t.rest }

let simplify equal t =
  let keep (before, acc) p =
    if equal before p.at && equal p.at p.after then (before, acc) else (p.after, p :: acc)
  in
  let _, rest = List.fold_left keep (t.first, []) t.rest in
  { t with rest = List.rev rest }

let of_cuts extent cuts equal f =
  let inside c = Rat.sign c > 0 && match extent with
    | Instant -> false
    | Lasts d -> Rat.compare c d < 0
    | Forever -> true
  in
  let cuts = List.sort_uniq Rat.compare (List.filter inside cuts) in
  refine (constant extent ())
    ~roots:(fun () -> List.map Algebraic.of_rat cuts)
    ~at:(fun r () ->
        match Algebraic.to_rat r with
        | Some r -> f r
        | None -> Scc_base.Bug.fail __POS__ "an irrational cut")
    ~inside:(fun r () -> f r)
  |> simplify equal

type moment = { offset : Algebraic.t; attained : bool }

let compare_moment a b =
  Algebraic.compare a.offset b.offset <?> fun () -> Bool.compare b.attained a.attained

let first_after_start test t =
  let rec go = function
    | [] -> None
    | p :: _ when test p.at -> Some { offset = p.cut; attained = true }
    | p :: _ when test p.after -> Some { offset = p.cut; attained = false }
    | _ :: later -> go later
  in
  match t.extent with
  | Instant -> None
  | Lasts _ | Forever ->
    if test t.first then Some { offset = Algebraic.zero; attained = false } else go t.rest

let sample t m =
  if m.attained then m.offset
  else
    let later = List.find_opt (fun p -> Algebraic.compare p.cut m.offset > 0) t.rest in
    Algebraic.of_rat (inner t.extent m.offset (Option.map (fun p -> p.cut) later))

let at t offset =
  let rec go value = function
    | [] -> value
    | p :: later ->
      let c = Algebraic.compare offset p.cut in
      if c < 0 then value else if c = 0 then p.at else go p.after later
  in
  if Algebraic.compare_rat offset Rat.zero = 0 then t.start else go t.first t.rest
