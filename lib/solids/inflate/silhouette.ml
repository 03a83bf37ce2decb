open Scc_pixels

type t = {
  width : int;
  height : int;
  inside : Bytes.t;
  size : int;
  left : int;
  top : int;
  picture : Raster.t;
}

type piece = { pixels : int; at : int * int }
type fault = Empty | Several of piece list | No_such_piece of piece list

let white = 0xffffff

let far_from a b =
  let apart shift = abs (((a lsr shift) land 255) - ((b lsr shift) land 255)) >= 128 in
  apart 16 || apart 8 || apart 0

let belongs ?background (p : Raster.t) =
  let opaque i = Bytes.get_uint8 p.alphas i >= 128 in
  let rec transparent i = i < Array.length p.colours && ((not (opaque i)) || transparent (i + 1)) in
  match background with
  | None when transparent 0 -> opaque
  | _ ->
    let background = Option.value background ~default:white in
    fun i -> opaque i && far_from p.colours.(i) background

(* The pieces: of each pixel the number of its piece from 1, or 0. *)
let label (p : Raster.t) belongs =
  let n = p.width * p.height in
  let labels = Array.make n 0 and queue = Array.make n 0 and pieces = ref [] and count = ref 0 in
  for start = 0 to n - 1 do
    if labels.(start) = 0 && belongs start then begin
      incr count;
      let first = ref 0 and last = ref 1 in
      let reach i =
        if labels.(i) = 0 && belongs i then begin
          labels.(i) <- !count;
          queue.(!last) <- i;
          incr last
        end
      in
      labels.(start) <- !count;
      queue.(0) <- start;
      while !first < !last do
        let i = queue.(!first) in
        incr first;
        let x = i mod p.width in
        if x > 0 then reach (i - 1);
        if x < p.width - 1 then reach (i + 1);
        if i >= p.width then reach (i - p.width);
        if i + p.width < n then reach (i + p.width)
      done;
      pieces := (!count, { pixels = !last; at = (start mod p.width, start / p.width) }) :: !pieces
    end
  done;
  (labels, List.stable_sort (fun (_, a) (_, b) -> compare b.pixels a.pixels) (List.rev !pieces))

(* The pixels whose labels are chosen. *)
let cut (p : Raster.t) labels chosen size =
  let left = ref p.width and right = ref (-1) and top = ref p.height and bottom = ref (-1) in
  let each f = Array.iteri (fun i l -> if chosen l then f (i mod p.width) (i / p.width)) labels in
  each (fun x y ->
      left := min !left x;
      right := max !right x;
      top := min !top y;
      bottom := max !bottom y);
  let width = !right - !left + 3 and height = !bottom - !top + 3 in
  let inside = Bytes.make (width * height) '\000' in
  each (fun x y -> Bytes.set inside (((y - !top + 1) * width) + x - !left + 1) '\001');
  { width; height; inside; size; left = !left - 1; top = !top - 1; picture = p }

let find ?background ?piece (p : Raster.t) =
  let labels, pieces = label p (belongs ?background p) in
  let told () = List.map snd pieces in
  let one (number : int) = cut p labels (( = ) number) in
  match (pieces, piece) with
  | [], _ -> Error Empty
  | [ (number, only) ], None -> Ok (one number only.pixels)
  | _, None -> Error (Several (told ()))
  | _, Some k -> (
      match List.nth_opt pieces (k - 1) with
      | Some (number, piece) -> Ok (one number piece.pixels)
      | None -> Error (No_such_piece (told ())))

let find_all ?background (p : Raster.t) =
  match label p (belongs ?background p) with
  | _, [] -> Error Empty
  | labels, pieces ->
    let all = List.fold_left (fun n (_, piece) -> n + piece.pixels) 0 pieces in
    let one ((number : int), piece) = cut p labels (( = ) number) piece.pixels in
    Ok (cut p labels (fun l -> l > 0) all, List.map one pieces)

let surrounded s ~margin =
  let width = s.width + (2 * margin) and height = s.height + (2 * margin) in
  let inside = Bytes.make (width * height) '\000' in
  for y = 1 to height - 2 do
    Bytes.fill inside ((y * width) + 1) (width - 2) '\001'
  done;
  let size = (width - 2) * (height - 2) in
  { s with width; height; inside; size; left = s.left - margin; top = s.top - margin }

let is_inside s x y =
  x >= 0 && y >= 0 && x < s.width && y < s.height && Bytes.get s.inside ((y * s.width) + x) <> '\000'

let colour s i = s.picture.colours.(((i / s.width) + s.top) * s.picture.width + (i mod s.width) + s.left)

let colours s =
  let found = Hashtbl.create 16 in
  Bytes.iteri
    (fun i c ->
       if c <> '\000' then
         let colour = colour s i in
         Hashtbl.replace found colour (1 + Option.value (Hashtbl.find_opt found colour) ~default:0))
    s.inside;
  let order (a, m) (b, n) = match Int.compare n m with 0 -> Int.compare a b | c -> c in
  List.sort order (List.of_seq (Hashtbl.to_seq found))

(* Distances along columns first; then in each row the lower envelope of the parabolas over its pixels, of which
   only those from near pixels count: one that is farther away than what is known already ends the search. *)
let depth s =
  let w = s.width and h = s.height in
  let up = Array.make (w * h) 0 in
  for y = 1 to h - 1 do
    for x = 0 to w - 1 do
      let i = (y * w) + x in
      if Bytes.get s.inside i <> '\000' then up.(i) <- up.(i - w) + 1
    done
  done;
  for y = h - 2 downto 0 do
    for x = 0 to w - 1 do
      let i = (y * w) + x in
      up.(i) <- min up.(i) (up.(i + w) + 1)
    done
  done;
  let greatest = ref 0 in
  for i = 0 to (w * h) - 1 do
    let nearest = ref (up.(i) * up.(i)) and step = ref 1 in
    while !nearest > !greatest && !step * !step < !nearest do
      let at k = (up.(k) * up.(k)) + (!step * !step) in
      nearest := min !nearest (min (at (i - !step)) (at (i + !step)));
      incr step
    done;
    greatest := max !greatest !nearest
  done;
  !greatest
