open Scc_exact
open Scc_geometry

type t = { points : View.points; view : View.t }

let inner (f : View.face) = f.body = 1

(* {1 Triangles} *)

(* Twice the area of a triangle of the picture, times a positive number. *)
let turn (flat : Ivec.t array) a b c = Z.sign (Ivec.det flat.(a) flat.(b) flat.(c))

(* More corners than that take too long. *)
let most_corners = 200

(* Ears are cut off one by one: corners that turn left, without another corner in their triangle. [tries] is how
   many corners are still to be looked at until it is given up, as there is none where a polygon crosses itself.
*)
let triangles flat corners =
  let turn = turn flat in
  let rec clip found ring tries =
    match ring with
    | a :: b :: c :: rest when tries > 0 ->
      let blocks p =
        (not (List.exists (fun q -> Ivec.equal flat.(p) flat.(q)) [ a; b; c ]))
        && turn a b p >= 0 && turn b c p >= 0 && turn c a p >= 0
      in
      let side = turn a b c in
      if side = 0 then clip found (a :: c :: rest) (List.length rest + 2)
      else if side > 0 && not (List.exists blocks rest) then
        clip ([| a; b; c |] :: found) (a :: c :: rest) (List.length rest + 2)
      else clip found ((b :: c :: rest) @ [ a ]) (tries - 1)
    | _ -> found
  in
  let n = List.length corners in
  if n > most_corners then [] else clip [] corners n

(* Positive if the polygon runs counterclockwise in the picture. *)
let orientation (flat : Ivec.t array) corners =
  Rat.sign (Convex.area2 (Array.map (fun c -> flat.(c)) corners))

let reversed corners = Array.of_list (List.rev (Array.to_list corners))

let pieces (p : View.points) face corners =
  let there c = c >= 0 && c < Array.length p.world in
  let corners = Array.of_list (List.filter there (Array.to_list corners)) in
  if Array.length corners < 3 then []
  else
    match Face_check.check p.world corners with
    | Ok _ ->
      let found = View.facing ~body:0 ~face p corners in
      let found = if Option.is_some found then found else View.facing ~body:1 ~face p (reversed corners) in
      Option.to_list found
    | Error _ -> (
        match orientation p.flat corners with
        | 0 -> []
        | side ->
          let body = if side > 0 then 0 else 1 in
          let ring = if side > 0 then corners else reversed corners in
          let triangle t = View.facing ~body ~face p t in
          List.filter_map triangle (triangles p.flat (Array.to_list ring)))

let make camera ~origin positions faces =
  let corners, over = Ivec.of_vecs positions in
  let points = View.points camera ~origin corners over in
  let all = List.concat (Array.to_list (Array.mapi (pieces points) faces)) in
  { points; view = { faces = Array.of_list all; edges = [||]; points = [| points.flat; points.flat |] } }
