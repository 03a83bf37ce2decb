open Scc_exact

type body = { solids : int list; wall : bool; content : bool }

let none = function [] -> true | _ :: _ -> false

(* Is the second solid beyond a face of the first one that is turned away from the camera? *)
let beyond camera (p : View.solid) (q : View.solid) =
  let outside corners =
    let at i = p.corners.(corners.(i)) in
    let n = Ivec.cross (Ivec.sub (at 1) (at 0)) (Ivec.sub (at 2) (at 0)) in
    let height = Z.mul q.denominator (Ivec.dot n (at 0)) in
    let above c = Z.geq (Z.mul p.denominator (Ivec.dot n c)) height in
    Camera.sees_back camera ~normal:n (at 0) p.denominator && Array.for_all above q.corners
  in
  Array.exists outside p.faces

let find camera (solids : View.solid array) hidden bodies =
  let faces = (Hidden.view hidden).faces in
  let of_solid = Array.make (Array.length solids) [] in
  Array.iteri (fun i (f : View.face) -> of_solid.(f.body) <- i :: of_solid.(f.body)) faces;
  let glass = Array.make (Array.length solids) false in
  let through content =
    let shown = List.concat_map (fun s -> of_solid.(s)) content.solids in
    if List.for_all (fun i -> none (Hidden.pieces hidden i)) shown then begin
      let hiding = Array.make (Array.length solids) false in
      List.iter (fun i -> List.iter (fun j -> hiding.(faces.(j).body) <- true) (Hidden.hiders hidden i)) shown;
      let near s = hiding.(s) || List.for_all (fun b -> beyond camera solids.(s) solids.(b)) content.solids in
      let clear wall =
        if wall.wall && wall != content && List.exists (Array.get hiding) wall.solids then
          List.iter (fun s -> if near s then glass.(s) <- true) wall.solids
      in
      Array.iter clear bodies
    end
  in
  Array.iter (fun b -> if b.content then through b) bodies;
  Array.get glass
