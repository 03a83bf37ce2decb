(* Inflated shapes against the equations solved densely over the rationals, and against points of both surfaces. *)
open Scc_exact
open Scc_geometry
open Scc_pixels
open Scc_inflate
module G = QCheck2.Gen

(* {1 Icons} *)

(* Of rows of characters: a blank is outside, 1 to 9 are inside and grey. *)
let picture rows =
  let height = List.length rows and width = String.length (List.hd rows) in
  let r = Raster.create ~width ~height in
  List.iteri
    (fun y row ->
       String.iteri
         (fun x c ->
            let grey = if c = ' ' then 255 else 10 * (Char.code c - 48) in
            r.colours.((y * width) + x) <- (grey lsl 16) lor (grey lsl 8) lor grey)
         row)
    rows;
  Bytes.fill r.alphas 0 (width * height) '\255';
  r

let shape rows =
  match Silhouette.find ~piece:1 (picture rows) with
  | Ok s -> s
  | Error _ -> Alcotest.fail "no silhouette"

(* The strength of a pixel by its digit, so that they differ. *)
let strength s i = Rat.make (Z.of_int ((Silhouette.colour s i land 255) + 10)) (Z.of_int 30)

let greatest_of s strength =
  let g = ref Rat.zero in
  Bytes.iteri (fun i c -> if c <> '\000' then g := Rat.max !g (strength i)) s.Silhouette.inside;
  !g

let ignored _ = ()

let relief ?(profile = Relief.Diffused) s strength =
  let greatest = greatest_of s strength in
  let d = Diffusion.solve ~progress:ignored s ~strength ~greatest in
  (d, greatest, Option.get (Relief.make profile s d ~greatest))

let one _ = Rat.one

let icons =
  [
    ("one pixel", [ "1" ]);
    ("a row", [ "12345" ]);
    ("a square", [ "111"; "111"; "111" ]);
    ("an L", [ "1  "; "2  "; "345" ]);
    ("a ring", [ "11111"; "1   1"; "1 2 1"; "1   1"; "11111" ]);
    ("a ring that closes at a corner", [ "1111"; "1 1 "; "11 1"; " 111" ]);
    ("a comb", [ "1 1 1 1"; "1 1 1 1"; "9999999"; "1 1 1 1" ]);
    ("a blot", [ "  111  "; " 12321 "; "1234311"; " 12 21 "; "  1 1  " ]);
  ]

(* {1 The equations} *)

(* Gauss's elimination, of 4 v - (sum of neighbours) = 4 s. *)
let dense (s : Silhouette.t) strength =
  let pixels = List.filter (fun i -> Bytes.get s.inside i <> '\000') (List.init (s.width * s.height) Fun.id) in
  let pixels = Array.of_list pixels in
  let n = Array.length pixels in
  let four = Rat.of_int 4 in
  let coefficient i j =
    if i = j then four else if List.mem (abs (i - j)) [ 1; s.width ] then Rat.of_int (-1) else Rat.zero
  in
  let m =
    Array.map
      (fun i -> Array.append (Array.map (coefficient i) pixels) [| Rat.mul four (strength i) |])
      pixels
  in
  for k = 0 to n - 1 do
    for r = 0 to n - 1 do
      if r <> k && Rat.sign m.(r).(k) <> 0 then begin
        let f = Rat.div m.(r).(k) m.(k).(k) in
        for c = k to n do
          m.(r).(c) <- Rat.sub m.(r).(c) (Rat.mul f m.(k).(c))
        done
      end
    done
  done;
  Array.mapi (fun k i -> (i, Rat.div m.(k).(n) m.(k).(k))) pixels

let within what limit a b =
  if Rat.compare (Rat.abs (Rat.sub a b)) limit > 0 then
    Alcotest.failf "%s: %s and %s are more than %s apart" what (Rat.to_string a) (Rat.to_string b)
      (Rat.to_string limit)

let check_equations (name, rows) =
  let s = shape rows in
  let exact = dense s (strength s) in
  let d, greatest, diffused = relief s (strength s) in
  let unit = Rat.div greatest (Rat.of_int (1 lsl d.bits)) in
  let quanta q = Rat.make (Z.of_int q) (Z.of_int Relief.quanta) in
  let _, _, round = relief ~profile:Round s (strength s) in
  Array.iter
    (fun (i, v) ->
       within name (Rat.mul unit (Rat.of_int d.error)) v (Rat.mul unit (Rat.of_int d.values.(i)));
       within name diffused.off (Rat.div v diffused.radius) (quanta diffused.heights.(i));
       (* h - off <= root v <= h + off *)
       let h = quanta round.heights.(i) in
       let low = Rat.max Rat.zero (Rat.sub h round.off) and high = Rat.add h round.off in
       if Rat.compare (Rat.mul low low) v > 0 || Rat.compare (Rat.mul high high) v < 0 then
         Alcotest.failf "%s: a root is farther away than told" name)
    exact;
  (* What is told is of use, too. *)
  List.iter
    (fun (r : Relief.t) ->
       if Rat.compare r.off (Rat.make Z.one (Z.of_int 500)) > 0 then Alcotest.failf "%s: a poor bound" name)
    [ diffused; round ]

(* {1 Surfaces} *)

let closed name (mesh : Polyhedron.ifs) =
  let edges = Hashtbl.create 64 in
  Array.iter
    (fun (_, f) ->
       for k = 0 to 2 do
         let e = (f.(k), f.((k + 1) mod 3)) in
         if Hashtbl.mem edges e then Alcotest.failf "%s: an edge twice" name;
         Hashtbl.add edges e f.((k + 2) mod 3)
       done)
    mesh.ifs_faces;
  Hashtbl.iter (fun (a, b) _ -> if not (Hashtbl.mem edges (b, a)) then Alcotest.failf "%s: open" name) edges;
  (* Around each vertex the faces make one cycle. *)
  let degree = Array.make (Array.length mesh.ifs_vertices) 0 in
  Hashtbl.iter (fun (a, _) _ -> degree.(a) <- degree.(a) + 1) edges;
  Array.iteri
    (fun v d ->
       let start = Hashtbl.fold (fun (a, b) _ found -> if a = v then b else found) edges (-1) in
       if start < 0 then Alcotest.failf "%s: an unused vertex" name;
       let rec go b n = if b = start && n > 0 then n else go (Hashtbl.find edges (v, b)) (n + 1) in
       if go start 0 <> d then Alcotest.failf "%s: a pinched vertex" name)
    degree;
  Hashtbl.length edges / 2

(* The front is a graph: its triangles turn one way in the plane, and their areas add up to that of the outline,
   which only happens when they do not overlap; heights are above 0 but at the outline. *)
let area loops =
  let one loop =
    let n = Array.length loop in
    let sum = ref 0 in
    Array.iteri
      (fun k (x, y) ->
         let x', y' = loop.((k + 1) mod n) in
         sum := !sum - ((x * y') - (x' * y)))
      loop;
    !sum
  in
  List.fold_left (fun n loop -> n + one loop) 0 loops

let check_solid name faces (s : Silhouette.t) (r : Relief.t) =
  match Solid_of.make ~progress:ignored ~faces ~scale:Rat.one r with
  | Error needed -> (match faces with Some n when needed > n -> None | _ -> Alcotest.failf "%s: refused" name)
  | Ok solid ->
    let mesh = solid.mesh in
    let edges = closed name mesh in
    let v = Array.length mesh.ifs_vertices and f = Array.length mesh.ifs_faces in
    (match faces with Some n -> Alcotest.(check bool) (name ^ ": few faces") true (f <= n) | None -> ());
    Alcotest.(check int) (name ^ ": genus") (2 - (2 * solid.holes)) (v - edges + f);
    let at k = snd mesh.ifs_vertices.(k) in
    let total = ref Rat.zero in
    Array.iteri
      (fun k (_, c) ->
         if k < f / 2 then begin
           let a = at c.(0) and b = at c.(1) and d = at c.(2) in
           let turn = (Vec.cross (Vec.sub b a) (Vec.sub d a)).z in
           if Rat.sign turn <= 0 then Alcotest.failf "%s: the front is no graph" name;
           if List.exists (fun (p : Vec.t) -> Rat.sign p.z < 0) [ a; b; d ]
           || List.for_all (fun (p : Vec.t) -> Rat.sign p.z = 0) [ a; b; d ]
           then Alcotest.failf "%s: front and back meet" name;
           total := Rat.add !total turn
         end)
      mesh.ifs_faces;
    (* No edge but those of the outline, which the back shares, lies at height 0. *)
    let flat = Hashtbl.create 16 in
    Array.iteri
      (fun k (_, c) ->
         for i = 0 to 2 do
           let a = c.(i) and b = c.((i + 1) mod 3) in
           if Rat.sign (at a).z = 0 && Rat.sign (at b).z = 0 then
             Hashtbl.add flat (min a b, max a b) (k < f / 2)
         done)
      mesh.ifs_faces;
    Hashtbl.iter
      (fun e _ -> if List.length (Hashtbl.find_all flat e) <> 2 then Alcotest.failf "%s: a flat chord" name)
      flat;
    if faces = None then begin
      let outline = area (Outline.trace s) in
      Alcotest.(check string) (name ^ ": area") (Rat.to_string (Rat.make (Z.of_int outline) (Z.of_int 64)))
        (Rat.to_string !total)
    end;
    Some solid

let check_solids (name, rows) =
  let s = shape rows in
  List.iter
    (fun profile ->
       let _, _, r = relief ~profile s (strength s) in
       List.iter
         (fun faces -> ignore (check_solid name faces s r))
         [ None; Some 6; Some 12; Some 20; Some 40; Some 80 ])
    [ Relief.Diffused; Round ];
  let _, _, r = relief s (strength s) in
  Alcotest.(check bool) (name ^ ": can be had at all") true (check_solid name (Some 200) s r <> None)

(* {1 Random icons} *)

let random_icon =
  let open G in
  let* width = int_range 1 14 and* height = int_range 1 12 and* fill = int_range 35 95 in
  list_repeat height
    (map (String.concat "")
       (list_repeat width
          (let* p = int_range 0 99 and* d = int_range 1 9 in
           return (if p < fill then string_of_int d else " "))))

(* The height at (x, y) in the plane of a triangle: numerator and denominator > 0. *)
let height_at t k x y =
  let a, b, c = Triangulation.corners t k in
  let a = Triangulation.vertex t a and b = Triangulation.vertex t b and c = Triangulation.vertex t c in
  let area (p : Front.corner) (q : Front.corner) = Front.cross p.x p.y q.x q.y x y in
  let u = area a b and v = area b c and w = area c a in
  (-((v * a.z) + (w * b.z) + (u * c.z)), -(u + v + w))

(* The least and greatest of H - G at points of a fine grid, and whether the told gap holds there. *)
let gap_holds rows =
  match Silhouette.find ~piece:1 (picture rows) with
  | Error _ -> true
  | Ok s ->
    let _, _, r = relief s (strength s) in
    let everything = Solid_of.everything r in
    List.for_all
      (fun corners ->
         let outline = Outline.simplify s ~most:corners (Outline.trace s) in
         match Refine.reaching ~progress:ignored r outline.loops ~most:(max 4 (everything / 5)) with
         | Error _ -> true
         | Ok t ->
           let told = Gap.between r t in
           let met = ref 0 in
           for y = 0 to 4 * s.height do
             for x = 0 to 4 * s.width do
               let n, d = Front.height r (2 * x) (2 * y) in
               let n', d' =
                 match Triangulation.locate t (2 * x) (2 * y) with
                 | None -> (0, 1)
                 | Some k -> height_at t k (2 * x) (2 * y)
               in
               let off = abs ((n * d') - (n' * d)) in
               met := max !met ((off + (d * d') - 1) / (d * d'))
             done
           done;
           (* Differences grow along rays to their corners: a grid of quarter pixels comes near, if not to all. *)
           !met <= told && (told <= 2 || 4 * !met >= told))
      [ 3; 6; 1000 ]

let solid_holds rows =
  match Silhouette.find ~piece:1 (picture rows) with
  | Error _ -> true
  | Ok s ->
    let _, _, r = relief s (strength s) in
    List.iter (fun faces -> ignore (check_solid "random" faces s r)) [ None; Some 10; Some 30; Some 60; Some 100 ];
    true

(* The images of an icon under the symmetries of the square have the images of its heights. *)
let mirror rows =
  List.map (fun row -> String.init (String.length row) (fun k -> row.[String.length row - 1 - k])) rows

let symmetric rows =
  let both = List.map2 (fun a b -> a ^ b) rows (mirror rows) in
  match Silhouette.find ~piece:1 (picture both) with
  | Error _ -> true
  | Ok s ->
    let _, _, r = relief s (strength s) in
    let at x y = r.heights.((y * s.width) + x) in
    let pieces_straddle = s.left + s.left + s.width = String.length (List.hd both) in
    (not pieces_straddle)
    || List.for_all
      (fun y -> List.for_all (fun x -> at x y = at (s.width - 1 - x) y) (List.init s.width Fun.id))
      (List.init s.height Fun.id)

let turned () =
  let rows = [ " 11 "; "1221"; "1221"; " 11 " ] in
  let s = shape rows in
  let _, _, r = relief s (strength s) in
  for y = 0 to s.height - 1 do
    for x = 0 to s.width - 1 do
      let at x y = r.heights.((y * s.width) + x) in
      Alcotest.(check int) "a quarter turn" (at x y) (at (s.width - 1 - y) x)
    done
  done;
  match check_solid "turned" None s r with
  | None -> Alcotest.fail "no solid"
  | Some solid ->
    let places = Array.to_list (Array.map snd solid.mesh.ifs_vertices) in
    let has (p : Vec.t) = List.exists (Vec.equal p) places in
    List.iter
      (fun (p : Vec.t) ->
         Alcotest.(check bool) "mirrored" true (has { p with z = Rat.neg p.z });
         Alcotest.(check bool) "turned" true (has { p with x = Rat.neg p.y; y = p.x }))
      places

(* In 1/256 of a pixel. *)
let by_hand () =
  let height rows = let _, _, r = relief (shape rows) one in r.heights in
  Alcotest.(check int) "one pixel" 256 (height [ "1" ]).(4);
  (* 4 v - v = 4, and the radius is 1. *)
  Alcotest.(check int) "two" 341 (height [ "11" ]).(5);
  (* 4 a - b = 4 and 4 b - 2 a = 4: b = 12/7. *)
  Alcotest.(check int) "three" 439 (height [ "111" ]).(7)

(* Four centres are parted along the higher diagonal, whichever way that runs. *)
let diagonals () =
  List.iter
    (fun (name, rows) ->
       let s = shape rows in
       let _, _, r = relief s (strength s) in
       let at x y = r.heights.((y * s.width) + x) in
       for y = 0 to s.height - 2 do
         for x = 0 to s.width - 2 do
           let a = at x y and b = at (x + 1) y and c = at (x + 1) (y + 1) and d = at x (y + 1) in
           if a > 0 && b > 0 && c > 0 && d > 0 then begin
             let n, over = Front.height r ((8 * x) + 4) ((8 * y) + 4) in
             Alcotest.(check int) name (over * max (a + c) (b + d)) (2 * n)
           end
         done
       done)
    icons

let outlines () =
  let count rows = List.map Array.length (Outline.trace (shape rows)) in
  Alcotest.(check (list int)) "a pixel" [ 4 ] (count [ "1" ]);
  Alcotest.(check (list int)) "a ring" [ 12; 4 ] (count [ "111"; "1 1"; "111" ]);
  (* What is in the middle is joined to what is outside, at the corner: a single line of 16 corners. *)
  Alcotest.(check (list int)) "touching corners stay apart" [ 16 ] (count [ "11 "; "1 1"; "111" ]);
  let pieces rows = match Silhouette.find (picture rows) with Error (Several p) -> List.length p | _ -> 1 in
  Alcotest.(check int) "corners do not join" 2 (pieces [ "1 "; " 1" ])

let () =
  let one name check ((n, _) as icon) = Alcotest.test_case (name ^ ": " ^ n) `Quick (fun () -> check icon) in
  let icons_case name check = List.map (one name check) icons in
  let property name count gen law =
    Scc_test_support.Property.case (QCheck2.Test.make ~name ~count ~print:(String.concat "\n") gen law) in
  Alcotest.run "inflate"
    [
      ("equations", icons_case "dense elimination" check_equations);
      ( "by hand",
        [ Alcotest.test_case "small icons" `Quick by_hand; Alcotest.test_case "outlines" `Quick outlines;
          Alcotest.test_case "the higher diagonal" `Quick diagonals;
          Alcotest.test_case "symmetric icons give symmetric solids" `Quick turned ] );
      ("solids", icons_case "closed, and front and back apart" check_solids);
      ( "random",
        [
          property "solids are closed and do not meet themselves" 60 random_icon solid_holds;
          property "the told gap is the greatest difference" 60 random_icon gap_holds;
          property "mirrored icons have mirrored heights" 60 random_icon symmetric;
          property "heights are as near as told" 25 random_icon (fun rows ->
              match Silhouette.find ~piece:1 (picture rows) with
              | Error _ -> true
              | Ok s -> s.size > 60 || (check_equations ("random", rows); true));
        ] );
    ]
