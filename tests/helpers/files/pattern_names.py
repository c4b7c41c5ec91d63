"""Names of measurements that pattern programs know, kept apart from those of the package.

`SEAMLY` holds the known measurements of Seamly2D and Valentina that a body may have (groups A, B, D
to O). `FREESEWING` holds all measurements of FreeSewing.
"""

SEAMLY = frozenset(
    """
    height head_circ head_length head_depth head_width head_crown_to_neck_back
    hand_palm_length hand_length hand_palm_width hand_palm_circ
    foot_width foot_length foot_circ foot_instep_circ leg_ankle_diag_circ
    height_neck_back height_scapula height_armpit height_waist_side height_hip height_gluteal_fold
    height_knee height_calf height_ankle_high height_ankle height_highhip height_waist_front
    height_bustpoint height_shoulder_tip height_neck_front height_neck_side height_waist_back
    height_neck_back_to_knee height_waist_side_to_knee height_waist_side_to_hip
    height_knee_to_ankle height_neck_back_to_waist_side
    width_shoulder width_bust width_waist width_hip width_abdomen_to_hip
    neck_mid_circ neck_circ highbust_circ bust_circ lowbust_circ rib_circ waist_circ highhip_circ
    hip_circ neck_arc_f highbust_arc_f bust_arc_f lowbust_arc_f rib_arc_f waist_arc_f highhip_arc_f
    hip_arc_f neck_arc_b highbust_arc_b bust_arc_b lowbust_arc_b rib_arc_b waist_arc_b
    highhip_arc_b hip_arc_b body_armfold_circ body_bust_circ body_torso_circ
    neck_front_to_waist_f neck_front_to_waist_flat_f armpit_to_waist_side
    shoulder_tip_to_waist_side_f neck_side_to_waist_f neck_side_to_waist_bustpoint_f
    neck_front_to_highbust_f highbust_to_waist_f neck_front_to_bust_f bust_to_waist_f
    lowbust_to_waist_f rib_to_waist_side shoulder_tip_to_armfold_f neck_side_to_bust_f
    neck_side_to_highbust_f shoulder_center_to_highbust_f shoulder_tip_to_waist_side_b
    neck_side_to_waist_b neck_back_to_waist_b neck_side_to_waist_scapula_b neck_back_to_highbust_b
    highbust_to_waist_b neck_back_to_bust_b bust_to_waist_b lowbust_to_waist_b
    shoulder_tip_to_armfold_b neck_side_to_bust_b neck_side_to_highbust_b
    shoulder_center_to_highbust_b waist_to_highhip_f waist_to_hip_f waist_to_highhip_side
    waist_to_highhip_b waist_to_hip_b waist_to_hip_side shoulder_slope_neck_side_angle
    shoulder_slope_neck_side_length shoulder_slope_neck_back_angle shoulder_slope_neck_back_height
    shoulder_slope_shoulder_tip_angle neck_back_to_across_back across_back_to_waist_b
    shoulder_length shoulder_tip_to_shoulder_tip_f across_chest_f armfold_to_armfold_f
    shoulder_tip_to_shoulder_tip_b across_back_b armfold_to_armfold_b neck_front_to_shoulder_tip_f
    neck_back_to_shoulder_tip_b neck_width
    bustpoint_to_bustpoint bustpoint_to_neck_side bustpoint_to_lowbust bustpoint_to_waist
    bustpoint_neck_side_to_waist bustpoint_to_shoulder_tip bustpoint_to_waist_front
    bustpoint_to_bustpoint_halter bustpoint_to_shoulder_center
    arm_shoulder_tip_to_wrist arm_shoulder_tip_to_elbow arm_elbow_to_wrist arm_armpit_to_wrist
    arm_armpit_to_elbow arm_elbow_to_wrist_inside arm_upper_circ arm_above_elbow_circ
    arm_elbow_circ arm_lower_circ arm_wrist_circ arm_shoulder_tip_to_armfold_line
    arm_neck_side_to_wrist armscye_circ armscye_length armscye_width arm_neck_side_to_outer_elbow
    leg_crotch_to_floor leg_waist_side_to_floor leg_thigh_upper_circ leg_thigh_mid_circ
    leg_knee_circ leg_knee_small_circ leg_calf_circ leg_ankle_high_circ leg_ankle_circ
    leg_crotch_to_ankle leg_waist_side_to_ankle leg_waist_side_to_knee
    crotch_length crotch_length_b crotch_length_f rise_length_diag rise_length_b rise_length_f
    rise_length_side neck_back_to_waist_front waist_to_waist_halter waist_natural_circ
    waist_natural_arc_f waist_natural_arc_b waist_to_natural_waist_f waist_to_natural_waist_b
    """.split()  # noqa: SIM905
)

FREESEWING = frozenset(
    """
    ankle biceps bustFront bustPointToUnderbust bustSpan chest crossSeam crossSeamFront crotchDepth
    head heel highBust highBustFront hips hpsToBust hpsToWaistBack hpsToWaistFront inseam knee neck
    seat seatBack shoulderSlope shoulderToElbow shoulderToShoulder shoulderToWrist underbust
    upperLeg waist waistBack waistToArmpit waistToFloor waistToHips waistToKnee waistToSeat
    waistToUnderbust waistToUpperLeg wrist
    """.split()  # noqa: SIM905
)
