open Cmdliner

type t = { number : int;  (** from 1 on *) all : int }

let range part ~count =
  match part with
  | None -> (0, count)
  | Some p ->
    (* The product may be longer than a word. *)
    let up_to k = Z.to_int (Z.div (Z.mul (Z.of_int count) (Z.of_int k)) (Z.of_int p.all)) in
    (up_to (p.number - 1), up_to p.number)

let part_conv =
  let parse s =
    match List.map int_of_string_opt (String.split_on_char '/' s) with
    | [ Some number; Some all ] when 1 <= number && number <= all -> Ok { number; all }
    | _ -> Error (`Msg (Printf.sprintf "`%s' is no part: the third of eight is 3/8" s))
  in
  Arg.conv ~docv:"K/N" (parse, fun ppf p -> Format.fprintf ppf "%d/%d" p.number p.all)

let option ~what =
  let doc =
    Printf.sprintf
      "Makes only part $(i,K) of $(i,N) parts of the %s, with $(i,K) from 1 on. The lines of all parts, one part \
       after the other, without the first line of each but the first, are those of the whole."
      what
  in
  Arg.(value & opt (some part_conv) None & info [ "part" ] ~docv:"K/N" ~doc)
