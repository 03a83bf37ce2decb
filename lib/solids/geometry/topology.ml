type edge = { tail : int; head : int; left : int; right : int }
type t = { edges : edge array; first : int array; neighbour : int array; along : int array }

(* For each vertex the edges that leave it: where to, and the face on the left. *)
let leaving count faces =
  let out = Array.make count [] in
  let add_face i corners =
    let k = Array.length corners in
    Array.iteri (fun j v -> out.(v) <- (corners.(if j + 1 = k then 0 else j + 1), i) :: out.(v)) corners
  in
  Array.iteri add_face faces;
  out

let make n faces edges =
  let out = leaving n faces in
  let face v w =
    match List.find_opt (fun (u, _) -> Int.equal u w) out.(v) with
    | Some (_, f) -> f
    | None -> Scc_base.Bug.fail __POS__ "an edge of a solid has no face"
  in
  let edges = Array.map (fun (v, w) -> { tail = v; head = w; left = face v w; right = face w v }) edges in
  let at = Array.make n [] in
  Array.iteri
    (fun i e ->
       at.(e.tail) <- (e.head, i) :: at.(e.tail);
       at.(e.head) <- (e.tail, i) :: at.(e.head))
    edges;
  let first = Array.make (n + 1) 0 in
  Array.iteri (fun v around -> first.(v + 1) <- first.(v) + List.length around) at;
  let flat = Array.of_list (List.concat_map List.rev (Array.to_list at)) in
  { edges; first; neighbour = Array.map fst flat; along = Array.map snd flat }

let edge_between t v w =
  let rec search i last =
    if i = last then None else if t.neighbour.(i) = w then Some t.along.(i) else search (i + 1) last
  in
  search t.first.(v) t.first.(v + 1)

(* Whether an edge at [v] has the face [f]: then [v] is one of its corners. *)
let has_face t v f =
  let rec search i last =
    i < last
    &&
    let e = t.edges.(t.along.(i)) in
    e.left = f || e.right = f || search (i + 1) last
  in
  search t.first.(v) t.first.(v + 1)

(* Every face at [u] is on the left of one of the edges there, seen as leaving [u]. *)
let common_face t u v w =
  let rec search i last =
    if i = last then None
    else
      let e = t.edges.(t.along.(i)) in
      let f = if e.tail = u then e.left else e.right in
      if has_face t v f && has_face t w f then Some f else search (i + 1) last
  in
  search t.first.(u) t.first.(u + 1)
