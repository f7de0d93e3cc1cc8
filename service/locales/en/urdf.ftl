# URDF and the workspace.

error-urdf_not_xml = The text is not well-formed XML: line { $line }, column { $column }.
error-urdf_unsafe = A URDF has no document type and no entities, and refers to no other file. Remove <!DOCTYPE …>.
error-urdf_too_long = The description is longer than { $limit } characters.
error-urdf_too_complex = The description is nested deeper than { $depth } or has more than { $elements } elements.
error-urdf_no_robot = The root element is <{ $found }>; a URDF begins with <robot>.
error-urdf_is_xacro = This is xacro, a macro language. Expand it first: xacro robot.xacro > robot.urdf
error-urdf_no_links = The description has no links.
error-urdf_name_missing = An element <{ $element }> has no name.
error-urdf_name_twice = Two elements <{ $element }> are called “{ $name }”.
error-urdf_name_invalid = A name is one line of visible characters.
error-urdf_joint_incomplete = Joint “{ $joint }” lacks <{ $element } link="…"/>.
error-urdf_link_missing = Joint “{ $joint }” names the link “{ $link }”, which the description does not have.
error-urdf_link_unknown = The description has no link “{ $link }”; it has { $known }.
error-urdf_links_alike = The first link and the last one need different names; both were “{ $link }”.
error-urdf_two_parents = Link “{ $link }” is the child of two joints, “{ $first }” and “{ $second }”. Each link has one parent.
error-urdf_ring = The links form a loop through “{ $link }”. A description is a tree.
error-urdf_base_needed = { $count } links have no parent. Name one of them as base_link: { $links }.
error-urdf_tip_needed = The description branches and has { $count } ends. Name one of them as tip_link: { $links }.
error-urdf_no_path = No joints lead from link “{ $base }” to link “{ $tip }”.
error-urdf_nothing_moves = Nothing moves between link “{ $base }” and link “{ $tip }”.
error-urdf_too_many_joints = The chain has { $count } moving joints; a table takes at most { $limit }.
error-urdf_several_freedoms = Joint “{ $joint }” is { $kind }: it has several degrees of freedom, and a row of a DH table has one.
error-urdf_type_unknown = Joint “{ $joint }” is of the type “{ $kind }”; the known types are { $known }.
error-urdf_mimic = Joint “{ $joint }” moves with “{ $other }”, and both are in the chain; in a DH table every joint has a variable of its own.
error-urdf_mimic_unknown = Joint “{ $joint }” mimics “{ $other }”, which is not a joint of the description.
error-urdf_mimic_circle = Joint “{ $joint }” has nothing to move with: following what it mimics leads round in a circle ({ $circle }).
error-urdf_attribute_unknown = Joint “{ $joint }”: <{ $element }> has no attribute “{ $attribute }”; its attributes are { $known }.
error-urdf_element_twice = Joint “{ $joint }” has several elements <{ $element }> that differ. Keep one of them.
error-urdf_two_orientations = Joint “{ $joint }” gives its orientation twice, as rpy and as quat_xyzw. Keep one of them.
error-urdf_quaternion_zero = The quaternion of joint “{ $joint }” is 0 0 0 0, which is not an orientation.
error-urdf_joint_names = A robot with { $expected ->
    [one] one joint
   *[other] { $expected } joints
} takes as many joint names, all different, and none of them fixed_base, fixed_tool or fixed_row_…; { $given } { $given ->
    [one] was
   *[other] were
} given.
error-urdf_link_names = A robot with { $expected ->
    [one] one joint
   *[other] { $expected } joints
} takes as many names of links, one for what each joint carries, all different; { $given } { $given ->
    [one] was
   *[other] were
} given.
error-urdf_axis_zero = The axis of joint “{ $joint }” is 0 0 0, which has no direction.
error-urdf_limits_reversed = The lower limit of joint “{ $joint }” is greater than its upper limit.
error-urdf_numbers_malformed = Joint “{ $joint }”: { $attribute } in <{ $element }> takes { $count ->
        [one] one finite number
       *[other] { $count } finite numbers separated by spaces
    }, none larger than { $limit }.
error-urdf_limit_malformed = Joint “{ $joint }”: { $attribute } in <limit> takes one number. Write inf where the joint has no limit.
error-urdf_limit_overflow = A limit in a URDF is at most { $limit } (rad or m) in size. Give null where there is none.
error-urdf_length_overflow = The lengths of a URDF must be at most { $limit_in_metres } m.
error-option_idle = Leave out { $found }: this conversion does not use it.

error-workspace_without_joints = Nothing moves: a workspace needs a revolute or a prismatic row.
error-slide_without_limits = Joint { $joint } slides: without a least and a greatest value the workspace is unbounded.
